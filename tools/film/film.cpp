#include "tools/film/film.h"

#include <fmt/format.h>

#include <cassert>
#include <stdexcept>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace linkdig::tools {
namespace {

struct Free {
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
    void operator()(AVFormatContext* format) const {
        if (format->pb != nullptr) avio_closep(&format->pb);
        avformat_free_context(format);
    }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

[[noreturn]] void fail(const std::string& path, const std::string& what, int error = 0) {
    char reason[AV_ERROR_MAX_STRING_SIZE] = "";
    if (error < 0) av_strerror(error, reason, sizeof reason);
    throw std::runtime_error(fmt::format("{}: {}{}{}", path, what, error < 0 ? ": " : "", reason));
}

/// H.264 where the library has it, else MPEG-4 part 2, which every build has.
const AVCodec* encoder(const std::string& path) {
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    if (codec == nullptr) codec = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
    if (codec == nullptr) fail(path, "cannot be written: libavcodec has neither libx264 nor mpeg4");
    return codec;
}

} // namespace

struct Film::State {
    std::string path;
    Owned<AVFormatContext> format;
    Owned<AVCodecContext> codec;
    Owned<AVFrame> frame;
    Owned<AVPacket> packet;
    Owned<SwsContext> scaler;
    AVStream* stream = nullptr;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::int64_t count = 0; ///< pictures taken so far

    void open_codec(int frames_per_second);
    void open_file();
    void open_picture();
    void encode(const AVFrame* picture);
};

void Film::State::open_codec(int frames_per_second) {
    const AVCodec* found = encoder(path);
    codec.reset(avcodec_alloc_context3(found));
    codec->width = static_cast<int>(width & ~1U);
    codec->height = static_cast<int>(height & ~1U);
    codec->pix_fmt = AV_PIX_FMT_YUV420P;
    codec->time_base = {1, frames_per_second};
    codec->framerate = {frames_per_second, 1};
    codec->gop_size = frames_per_second * 2;
    codec->thread_count = 1; // how x264 cuts a picture among threads changes its bytes
    codec->flags |= AV_CODEC_FLAG_BITEXACT;
    if ((format->oformat->flags & AVFMT_GLOBALHEADER) != 0) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (found->id == AV_CODEC_ID_H264) {
        av_opt_set(codec->priv_data, "preset", "veryfast", 0);
        av_opt_set(codec->priv_data, "crf", "20", 0);
        // Its vector code reads past the row of a small picture: films then differ from run to run (seen with
        // x264 164).
        av_opt_set(codec->priv_data, "mbtree", "0", 0);
    } else {
        codec->bit_rate = std::int64_t{6} * codec->width * codec->height;
    }
    if (const int error = avcodec_open2(codec.get(), found, nullptr); error < 0)
        fail(path, "the encoder refused the film", error);
}

void Film::State::open_file() {
    stream = avformat_new_stream(format.get(), nullptr);
    if (stream == nullptr) fail(path, "no stream could be added");
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = codec->framerate;
    avcodec_parameters_from_context(stream->codecpar, codec.get());
    if (const int error = avio_open(&format->pb, path.c_str(), AVIO_FLAG_WRITE); error < 0)
        fail(path, "cannot be written", error);
    if (const int error = avformat_write_header(format.get(), nullptr); error < 0)
        fail(path, "cannot be written", error);
}

void Film::State::open_picture() {
    packet.reset(av_packet_alloc());
    frame.reset(av_frame_alloc());
    frame->format = codec->pix_fmt;
    frame->width = codec->width;
    frame->height = codec->height;
    if (const int error = av_frame_get_buffer(frame.get(), 0); error < 0)
        fail(path, "no memory for a picture", error);
    scaler.reset(sws_getContext(codec->width, codec->height, AV_PIX_FMT_RGBA, codec->width, codec->height,
                                AV_PIX_FMT_YUV420P, SWS_BILINEAR | SWS_BITEXACT | SWS_ACCURATE_RND, nullptr,
                                nullptr, nullptr));
    if (!scaler) fail(path, "libswscale cannot convert pictures of this size");
}

void Film::State::encode(const AVFrame* picture) {
    int error = avcodec_send_frame(codec.get(), picture);
    while (error >= 0) {
        error = avcodec_receive_packet(codec.get(), packet.get());
        if (error == AVERROR(EAGAIN) || error == AVERROR_EOF) return;
        if (error >= 0) {
            av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
            packet->stream_index = stream->index;
            error = av_interleaved_write_frame(format.get(), packet.get());
        }
    }
    fail(path, "a picture could not be written", error);
}

bool video_files() { return true; }

Film::Film(const std::string& path, std::uint32_t width, std::uint32_t height,
           std::uint32_t frames_per_second)
    : state_(std::make_unique<State>()) {
    assert(frames_per_second >= 1 && frames_per_second <= 240);
    state_->path = path;
    state_->width = width;
    state_->height = height;
    if (width < 2 || height < 2)
        fail(state_->path, fmt::format("a film of {} x {} pixels cannot be made; at least 2 x 2 are needed",
                                       width, height));
    av_log_set_level(AV_LOG_ERROR); // x264 tells its statistics otherwise
    AVFormatContext* format = nullptr;
    if (const int error = avformat_alloc_output_context2(&format, nullptr, "mp4", state_->path.c_str());
        error < 0)
        fail(state_->path, "libavformat cannot make an mp4 file", error);
    state_->format.reset(format);
    format->flags |= AVFMT_FLAG_BITEXACT; // no date, no version of the library
    state_->open_codec(static_cast<int>(frames_per_second));
    state_->open_file();
    state_->open_picture();
}

Film::~Film() = default;

void Film::add(const ig::VideoFrame& picture) {
    assert(picture.width == state_->width && picture.height == state_->height);
    AVFrame* frame = state_->frame.get();
    if (const int error = av_frame_make_writable(frame); error < 0)
        fail(state_->path, "no memory for a picture", error);
    const auto* pixels = reinterpret_cast<const std::uint8_t*>(picture.pixels.data());
    const int stride = static_cast<int>(picture.width * sizeof(std::uint32_t));
    sws_scale(state_->scaler.get(), &pixels, &stride, 0, state_->codec->height, frame->data, frame->linesize);
    frame->pts = state_->count++;
    state_->encode(frame);
}

void Film::finish() {
    state_->encode(nullptr);
    if (const int error = av_write_trailer(state_->format.get()); error < 0)
        fail(state_->path, "could not be finished", error);
    if (const int error = avio_closep(&state_->format->pb); error < 0)
        fail(state_->path, "could not be closed", error);
}

} // namespace linkdig::tools
