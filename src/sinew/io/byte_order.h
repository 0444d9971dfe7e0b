/// @file byte_order.h
/// Numbers as bytes, in an order that does not depend on the machine's own.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace sinew {

/// Writes or reads a number whose bytes come in the given order; `put` returns where the next one goes.
template <class Number>
char* put_bytes(char* at, Number number, std::endian order) {
    std::memcpy(at, &number, sizeof number);
    if (order != std::endian::native) std::reverse(at, at + sizeof number);
    return at + sizeof number;
}
template <class Number>
Number get_bytes(const char* at, std::endian order) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, at, sizeof bytes);
    if (order != std::endian::native) std::reverse(bytes, bytes + sizeof bytes);
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

template <class Number>
char* put_little_endian(char* at, Number number) {
    return put_bytes(at, number, std::endian::little);
}

}  // namespace sinew
