/// @file choices.h
/// Actions that set one member of the settings or tools to one value, or turn it on and off.
#pragma once

#include "actions/action.h"

namespace sinew::modeler {

template <class T>
T& chosen(const Context& c, T ViewSettings::*member) {
    return c.view.*member;
}
template <class T>
T& chosen(const Context& c, T Interaction::*member) {
    return c.tools.*member;
}

template <auto member, auto value>
void choose(Context& c) {
    chosen(c, member) = value;
}
template <auto member, auto value>
bool is_chosen(const Context& c) {
    return chosen(c, member) == value;
}

template <auto member>
void flip(Context& c) {
    chosen(c, member) = !chosen(c, member);
}
template <auto member>
bool is_on(const Context& c) {
    return chosen(c, member);
}

}  // namespace sinew::modeler
