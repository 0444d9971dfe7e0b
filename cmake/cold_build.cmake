# For builds from nothing (tools/test): several files a compilation, and headers of other libraries read once for each group
# of targets. Such headers are most of what a file costs. Where one file changes at a time it only costs, so the presets
# build without it, and each file still includes what it uses.
option(SINEW_COLD_BUILD "Compile a fresh clone in the least time" OFF)
option(SINEW_BATCH "With SINEW_COLD_BUILD: several files of a target at once" ON)

# sinew_batch(TARGET): several files at once. For targets whose files have no names in common.
function(sinew_batch target)
    if(SINEW_COLD_BUILD AND SINEW_BATCH)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    endif()
endfunction()

# sinew_headers(TARGET HEADERS...): headers that most of the target's files include.
function(sinew_headers target)
    if(SINEW_COLD_BUILD)
        target_precompile_headers(${target} PRIVATE ${ARGN})
        # So that ccache can tell what is in them.
        target_compile_options(${target} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
    endif()
endfunction()

# sinew_headers_of(TARGET OTHER): those of a target with the same flags, once for both.
function(sinew_headers_of target other)
    if(SINEW_COLD_BUILD)
        target_precompile_headers(${target} REUSE_FROM ${other})
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
endfunction()
