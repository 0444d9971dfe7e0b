# The flags that every target of the project, and none of its users, is built with.
add_library(sinew_flags INTERFACE)
target_compile_options(sinew_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers)
if(SINEW_COLD_BUILD)
    target_compile_options(sinew_flags INTERFACE -Wno-shadow)  # of what another file of the same compilation has
endif()
# The same bytes on every machine: no fused multiply-add behind the code's back.
target_compile_options(sinew_flags INTERFACE -ffp-contract=off)
if(SINEW_SANITIZE)
    add_compile_definitions(SINEW_SANITIZED)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
        -fno-omit-frame-pointer -O1 -g1 -D_GLIBCXX_ASSERTIONS)
    # AddressSanitizer stops at null pointers too; these three make every build half as long again.
    add_compile_options(-fno-sanitize=null,alignment,vptr)
    add_link_options(-fsanitize=address,undefined)
endif()
