# What `cmake --install` puts where, and how others find it: find_package(sinew), with COMPONENTS render for the renderer,
# or pkg-config with the packages sinew and sinew-render.
include(CMakePackageConfigHelpers)
include(cmake/public_headers.cmake)
set(SINEW_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/sinew)

install(TARGETS sinew EXPORT sinewTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS sinew_render EXPORT sinewRenderTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(part sinew sinewRender)
    install(EXPORT ${part}Targets NAMESPACE sinew:: DESTINATION ${SINEW_CMAKE_FOLDER})
endforeach()
sinew_install_headers(${SINEW_PUBLIC_HEADERS} ${SINEW_PUBLIC_RENDER_HEADERS})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sinewConfig.cmake.in ${CMAKE_BINARY_DIR}/sinewConfig.cmake
    INSTALL_DESTINATION ${SINEW_CMAKE_FOLDER})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/sinewConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/sinewConfig.cmake ${CMAKE_BINARY_DIR}/sinewConfigVersion.cmake
    DESTINATION ${SINEW_CMAKE_FOLDER})

set(SINEW_PKGCONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH SINEW_PREFIX_FROM_PKGCONFIG /prefix/${SINEW_PKGCONFIG_FOLDER} /prefix)
foreach(package sinew sinew-render)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${package}.pc.in ${CMAKE_BINARY_DIR}/${package}.pc @ONLY)
    install(FILES ${CMAKE_BINARY_DIR}/${package}.pc DESTINATION ${SINEW_PKGCONFIG_FOLDER})
endforeach()
