# What a machine can judge about the sources and the pages: layering, layout, examples, clang-tidy. Run once, in the preset with everything.

set(layering ${CMAKE_CURRENT_SOURCE_DIR}/layering)
add_test(NAME layering.tree COMMAND Python3::Interpreter ${layering}/check_layering.py ${CMAKE_SOURCE_DIR})
add_test(NAME layering.self_test COMMAND Python3::Interpreter ${layering}/self_test.py)
add_test(NAME style.format COMMAND bash ${CMAKE_SOURCE_DIR}/tools/format.sh)
add_test(NAME docs.walk COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/docs/walk_test.py
    ${CMAKE_SOURCE_DIR} $<TARGET_FILE:linkdig>)
add_test(NAME docs.frame_in_detail COMMAND Python3::Interpreter
    ${CMAKE_CURRENT_SOURCE_DIR}/docs/frame_in_detail_test.py ${CMAKE_SOURCE_DIR})
set_tests_properties(layering.tree layering.self_test style.format docs.walk docs.frame_in_detail
    PROPERTIES LABELS style SKIP_RETURN_CODE 77)

# clang-tidy, a stamp per source file: only what changed is looked at again, but a header's change concerns every file.
# It takes longer than compiling: the everyday run looks at the machine and its contracts, the long one at everything.
find_program(LINKDIG_CLANG_TIDY clang-tidy)
if(LINKDIG_CLANG_TIDY)
    set(sources)
    set(headers)
    foreach(folder database host ig tools)
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND sources ${found})
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.h)
        list(APPEND headers ${found})
    endforeach()
    set(everyday)
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
        if(relative MATCHES "^(ig|database/model|host/packet)/")
            list(APPEND everyday ${stamp})
        endif()
    endforeach()
    add_custom_target(tidy DEPENDS ${everyday})
    add_custom_target(tidy_all DEPENDS ${stamps})
    add_dependencies(tidy linkdig) # generated headers
    add_dependencies(tidy_all linkdig)
    foreach(target tidy tidy_all)
        add_test(NAME style.${target} COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target ${target} -j 2)
        set_tests_properties(style.${target} PROPERTIES LABELS style PROCESSORS 2 TIMEOUT 3600)
    endforeach()
    set_tests_properties(style.tidy_all PROPERTIES LABELS "style;long")
endif()
