# A project of somebody else's: finds the installed library and links it. The test copies this to CMakeLists.txt.
cmake_minimum_required(VERSION 3.22)
project(consumer LANGUAGES CXX)
find_package(sinew 0.1 REQUIRED COMPONENTS render)

add_executable(tube tube.cpp)
target_link_libraries(tube PRIVATE sinew::sinew)
add_executable(picture picture.cpp)
target_link_libraries(picture PRIVATE sinew::render)

# Each installed header alone, as strangers compile it.
get_target_property(include_folder sinew::sinew INTERFACE_INCLUDE_DIRECTORIES)
file(GLOB_RECURSE headers RELATIVE ${include_folder} ${include_folder}/*.h)
add_library(headers OBJECT)
target_link_libraries(headers PRIVATE sinew::render)
foreach(header ${headers})
    string(REPLACE / _ name ${header})
    file(WRITE ${CMAKE_BINARY_DIR}/${name}.cpp "#include \"${header}\"\n#include \"${header}\"\n")
    target_sources(headers PRIVATE ${CMAKE_BINARY_DIR}/${name}.cpp)
endforeach()
