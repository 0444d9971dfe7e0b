# libFuzzer (preset `sanitize`): the whole library is built with coverage, and each target links the fuzzer's main.
if(SINEW_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
        message(FATAL_ERROR "libFuzzer comes with clang: use the preset `sanitize`")
    endif()
    add_compile_options(-fsanitize=fuzzer-no-link)
    add_custom_target(fuzzers)
endif()

# sinew_fuzzer(NAME SOURCE): the program bin/fuzz_NAME. Its seeds lie in the folder tests/fuzz/corpus/NAME.
function(sinew_fuzzer name source)
    add_executable(fuzz_${name} ${source})
    target_link_libraries(fuzz_${name} PRIVATE sinew::sinew sinew_flags)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers fuzz_${name})
endfunction()
