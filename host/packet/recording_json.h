#pragma once
/// Recordings to and from text: one JSON object a line, the header first, then a packet each (packet_json.h).
///
///   {"linkdig_recording":1,"database_id":"0x1f","update_rate_hz":60.0,"history":""}
///   {"frame":0,"time_s":0.0, ...}
///
/// `history` is the bytes of the image generator's history as hexadecimal digits.

#include "host/packet/recording.h"

#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace linkdig {

/// A mistake in the text, named by its line: "line 3: channels[0].eye_m: expected ...".
class RecordingTextMistake : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws what RecordingReader::next throws; std::runtime_error if the text cannot be written.
void recording_to_json(RecordingReader& recording, std::ostream& text);
/// Likewise, as the file `path`, which gets its name when it is whole.
void recording_to_json(RecordingReader& recording, const std::string& path);

/// Writes the recording file `path`. Throws RecordingTextMistake, or std::runtime_error if it cannot be written; the file
/// gets its name when it is whole.
void json_to_recording(std::istream& text, const std::string& path);

} // namespace linkdig
