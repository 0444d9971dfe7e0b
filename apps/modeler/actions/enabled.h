/// @file enabled.h
/// When actions make sense.
#pragma once

#include "actions/action.h"

namespace sinew::modeler {

inline bool any_node(const Context& c) { return !c.model.document().nodes.empty(); }
inline bool any_selected(const Context& c) { return !c.model.selection().empty(); }
inline bool two_selected(const Context& c) { return c.model.selection().nodes.size() == 2; }
inline bool several_selected(const Context& c) { return c.model.selection().nodes.size() >= 2; }
inline bool symmetric(const Context& c) { return c.model.document().symmetry.kind != Symmetry::Kind::none; }

}  // namespace sinew::modeler
