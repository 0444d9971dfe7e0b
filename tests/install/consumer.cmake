# A project of somebody else's: finds the installed library and links it. The test copies this to CMakeLists.txt.
cmake_minimum_required(VERSION 3.22)
project(consumer LANGUAGES CXX)
find_package(sinew 0.1 REQUIRED COMPONENTS render)

add_executable(tube tube.cpp)
target_link_libraries(tube PRIVATE sinew::sinew)
add_executable(picture picture.cpp)
target_link_libraries(picture PRIVATE sinew::render)
