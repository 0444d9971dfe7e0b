# Release builds are made to be attacked: programs that land anywhere in memory (PIE), whose tables of functions are
# bound at the start and read-only from then on (full RELRO, BIND_NOW), with guarded stacks, checked copies (FORTIFY) and,
# where the processor has it, indirect jumps to marked places only (CET). tests/tools/hardening_test.py looks at what came
# of it. Meshes keep their bytes: none of it touches arithmetic.
option(SINEW_HARDEN "Harden release builds against attacks" ${PROJECT_IS_TOP_LEVEL})

include(CheckCXXCompilerFlag)
include(CheckPIESupported)
if(SINEW_HARDEN AND NOT SINEW_SANITIZE)
    check_pie_supported(LANGUAGES CXX)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
    set(SINEW_RELEASE "$<CONFIG:Release,RelWithDebInfo,MinSizeRel>")
    check_cxx_compiler_flag(-fstack-protector-strong SINEW_HAS_STACK_PROTECTOR)
    if(SINEW_HAS_STACK_PROTECTOR)
        add_compile_options($<${SINEW_RELEASE}:-fstack-protector-strong>)
    endif()
    check_cxx_compiler_flag(-fcf-protection=full SINEW_HAS_CET)
    if(SINEW_HAS_CET)
        add_compile_options($<${SINEW_RELEASE}:-fcf-protection=full>)
    endif()
    check_cxx_compiler_flag(-fstack-clash-protection SINEW_HAS_STACK_CLASH)
    if(SINEW_HAS_STACK_CLASH)
        add_compile_options($<${SINEW_RELEASE}:-fstack-clash-protection>)
    endif()
    # Undefined first: some distributions' compilers define another level by themselves.
    add_compile_options($<${SINEW_RELEASE}:-U_FORTIFY_SOURCE> $<${SINEW_RELEASE}:-D_FORTIFY_SOURCE=2>)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
        add_link_options($<${SINEW_RELEASE}:LINKER:-z,relro,-z,now>)
    endif()
endif()
