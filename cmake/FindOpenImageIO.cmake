# OpenImageIO by pkg-config: Debian's own CMake file asks for OpenCV's headers, which nothing here uses.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OPENIMAGEIO QUIET IMPORTED_TARGET GLOBAL OpenImageIO)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO REQUIRED_VARS OPENIMAGEIO_LIBRARIES VERSION_VAR OPENIMAGEIO_VERSION)
if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::OPENIMAGEIO)
endif()
