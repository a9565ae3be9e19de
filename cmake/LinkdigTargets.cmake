# What every target of the project shares: warnings as errors, and the flags that keep floats the same everywhere.

add_library(linkdig_flags INTERFACE)
target_compile_options(linkdig_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror
    # The same bytes from every compiler and build type: no fused multiply-add, no reordering.
    -ffp-contract=off -fno-fast-math -fno-math-errno
    # g++ 12 loses the rounding of (double)(float)x when its SLP vectoriser takes neighbouring components in pairs.
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# A build that watches itself: "address,undefined" or "thread".
set(LINKDIG_SANITIZE "" CACHE STRING "Sanitizers of the whole build, as -fsanitize takes them")
if(LINKDIG_SANITIZE)
    target_compile_options(linkdig_flags INTERFACE
        -fsanitize=${LINKDIG_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(linkdig_flags INTERFACE -fsanitize=${LINKDIG_SANITIZE})
endif()
if(LINKDIG_FUZZ) # what the fuzzers look at tells them which way it went
    target_compile_options(linkdig_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
target_compile_definitions(linkdig_flags INTERFACE GLM_FORCE_PURE GLM_FORCE_CTOR_INIT)
target_include_directories(linkdig_flags INTERFACE ${CMAKE_SOURCE_DIR})
target_include_directories(linkdig_flags SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/generated) # not ours to tidy

# linkdig_library(NAME folder...): every .cpp under the named folders of this directory, as one static library.
function(linkdig_library name)
    set(sources)
    foreach(folder IN LISTS ARGN)
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND sources ${found})
    endforeach()
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC linkdig_flags glm::glm fmt::fmt)
endfunction()

# linkdig_schema(TARGET schema.fbs): the C++ reader and writer of a FlatBuffers schema, under <build>/generated.
function(linkdig_schema target schema)
    get_filename_component(base ${schema} NAME_WE)
    file(RELATIVE_PATH relative ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${schema})
    get_filename_component(folder ${relative} DIRECTORY)
    set(output ${CMAKE_BINARY_DIR}/generated/${folder}/${base}_generated.h)
    add_custom_command(OUTPUT ${output}
        COMMAND ${LINKDIG_FLATC} --cpp --scoped-enums --reflect-names
                -o ${CMAKE_BINARY_DIR}/generated/${folder} ${CMAKE_CURRENT_SOURCE_DIR}/${schema}
        DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${schema} VERBATIM)
    target_sources(${target} PRIVATE ${output})
endfunction()
