# What a machine can judge about the sources and the pages: layering, layout, examples, clang-tidy. Run once, in the preset with everything.

set(layering ${CMAKE_CURRENT_SOURCE_DIR}/layering)
add_test(NAME layering.tree COMMAND Python3::Interpreter ${layering}/check_layering.py ${CMAKE_SOURCE_DIR})
add_test(NAME layering.self_test COMMAND Python3::Interpreter ${layering}/self_test.py)
add_test(NAME style.format COMMAND bash ${CMAKE_SOURCE_DIR}/tools/format.sh)
add_test(NAME docs.walk COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/walk_test.py
    ${CMAKE_SOURCE_DIR} $<TARGET_FILE:linkdig>)
set_tests_properties(layering.tree layering.self_test style.format docs.walk
    PROPERTIES LABELS style SKIP_RETURN_CODE 77)

# clang-tidy, a stamp per source file: only what changed is looked at again. A header's change concerns every file.
find_program(LINKDIG_CLANG_TIDY clang-tidy)
if(LINKDIG_CLANG_TIDY)
    set(code database host ig tools)
    set(patterns)
    foreach(folder IN LISTS code)
        list(APPEND patterns ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
    endforeach()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
    string(REPLACE "*.cpp" "*.h" patterns "${patterns}")
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${patterns})
    set(stamps)
    foreach(source IN LISTS sources)
        file(RELATIVE_PATH relative ${CMAKE_SOURCE_DIR} ${source})
        set(stamp ${CMAKE_BINARY_DIR}/tidy/${relative}.ok)
        get_filename_component(folder ${stamp} DIRECTORY)
        file(MAKE_DIRECTORY ${folder})
        add_custom_command(OUTPUT ${stamp}
            COMMAND ${LINKDIG_CLANG_TIDY} --quiet -p ${CMAKE_BINARY_DIR} ${source}
            COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
            DEPENDS ${source} ${headers} ${CMAKE_SOURCE_DIR}/.clang-tidy
            COMMENT "clang-tidy ${relative}" VERBATIM)
        list(APPEND stamps ${stamp})
    endforeach()
    add_custom_target(tidy DEPENDS ${stamps})
    add_dependencies(tidy linkdig) # generated headers
    add_test(NAME style.tidy COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target tidy -j 2)
    set_tests_properties(style.tidy PROPERTIES LABELS style PROCESSORS 2 TIMEOUT 1200)
endif()
