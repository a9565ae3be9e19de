#pragma once
/// Folders that ship with the program.

#include <string>

namespace linkdig::tools {

struct ShippedFolder {
    const char* what;      ///< for messages: "the shipped scenes"
    const char* variable;  ///< of the environment: it names another folder
    const char* source;    ///< in the source tree this program was built from
    const char* installed; ///< beside the folder of an installed program
};

/// The first that is there, in the order of the members. Throws std::runtime_error, naming the places, if there is none.
std::string shipped_folder(const ShippedFolder& folder);

} // namespace linkdig::tools
