# Rebuilds after a fresh checkout cost little where ccache is installed.
find_program(SINEW_CCACHE ccache)
if(SINEW_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SINEW_CCACHE})
endif()
