/// @file swc_format.h
/// Neuron morphologies, after INCF's specification of SWC: `id type x y z radius parent`, # starts a comment.
#pragma once

#include <string_view>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Reads a morphology; its unit is the micrometre. Ids may stand in any order; further columns are passed
/// over; every type is fine, and kept as the node's unknown key "swc_type" (1 soma, 2 axon, 3 dendrite ...).
///
/// Somata: the three-point soma of NeuroMorpho, a root and two samples of its radius beside it at a distance
/// of that radius, stands for one sphere and becomes one node. So does a contour: a closed loop of four or
/// more samples with small radii (with a warning). See swc_soma.h. Somata of other kinds (cylinders, a stack
/// of frustums) are bones.
///
/// Radii that are not positive are repaired, with a warning. Fails, with the line, for too few fields, what
/// is no number, numbers that are not finite, an id that is negative or used twice, a parent that does not
/// exist or is the sample itself, samples that are their own ancestors, and a file without samples.
Result<ReadSkeleton> parse_swc(std::string_view text, const ReadOptions& options = {});

/// Writes a morphology, parents before children and numbers to the last bit. Ids stay where they are above 0
/// and parents have the lower ones, otherwise the samples are numbered from 1. Links are lost, with a
/// warning.
Result<WrittenSkeleton> print_swc(const Document& document);

}  // namespace sinew
