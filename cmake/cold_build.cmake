# Several files a compilation: headers of others and their templates are then compiled once instead of for each file, which
# is most of what a file costs. For builds from nothing (tools/test); where one file changes at a time it only costs.
# Each file still includes what it uses: the presets build without it.
option(SINEW_UNITY "Compile several files of the libraries and of the command line at once" OFF)

function(sinew_unity target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${SINEW_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()
