# libFuzzer programs, one per target of targets.h, each run for a while from the seeds. What they find goes to tests/fuzz/found/TARGET
# and is a regression test of fuzz_test from then on.
if(NOT LINKDIG_FUZZ)
    return()
endif()
set(LINKDIG_FUZZ_SECONDS 60 CACHE STRING "How long each fuzzer runs as a test")
set(LINKDIG_FUZZ_SEED 1 CACHE STRING "The fuzzers' seed: the same finds for everybody; 0 for another at each run")

add_executable(write_seeds fuzz/programs/write_seeds.cpp fuzz/seeds.cpp ${samples})
target_link_libraries(write_seeds PRIVATE linkdig_host linkdig_database GTest::gtest)
add_test(NAME fuzz.seeds COMMAND write_seeds ${CMAKE_BINARY_DIR}/fuzz)
set_tests_properties(fuzz.seeds PROPERTIES FIXTURES_SETUP fuzz_seeds LABELS fuzz)

foreach(target packet_bytes packet_json database_file)
    add_executable(fuzz_${target} fuzz/programs/fuzzer.cpp fuzz/targets.cpp)
    target_compile_definitions(fuzz_${target} PRIVATE LINKDIG_FUZZ_TARGET=${target})
    target_link_libraries(fuzz_${target} PRIVATE linkdig_ig linkdig_host linkdig_database)
    target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer)
    add_test(NAME fuzz.${target} COMMAND fuzz_${target} -seed=${LINKDIG_FUZZ_SEED} -max_total_time=${LINKDIG_FUZZ_SECONDS} -max_len=16384 -timeout=10
        -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix=${CMAKE_BINARY_DIR}/fuzz/${target}_ ${CMAKE_BINARY_DIR}/fuzz/${target})
    set_tests_properties(fuzz.${target} PROPERTIES FIXTURES_REQUIRED fuzz_seeds LABELS fuzz TIMEOUT 600)
endforeach()
