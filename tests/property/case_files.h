/// @file case_files.h
/// Cases as files: a native document with one more key, "skin", for the options.
#pragma once

#include <filesystem>

#include "property/random_skeletons.h"
#include "sinew/base/result.h"

namespace sinew::property {

std::string print_case(const Case& tried);
Result<Case> read_case(const std::filesystem::path& file);

}  // namespace sinew::property
