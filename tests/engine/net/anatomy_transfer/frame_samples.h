#pragma once

#include <string>
#include <vector>

namespace carina::test
{

/// One frame of each kind, byte for byte as docs/anatomy-transfer.md lays it out.
struct GoldenFrame {
    const char* name;
    std::string bytes;
};

inline const std::string kContentHash = std::string(32, '0') + std::string(32, 'f');
inline const std::string kDigest(64, 'a');

/// The first bytes of a text that holds zeros.
template <std::size_t Size> std::string raw(const char (&text)[Size]) { return {text, Size - 1}; }

inline std::vector<GoldenFrame> goldenFrames()
{
    return {
        {"want", raw("\x01\x43\0\0\0"
                     "CS\x01")
                     + kContentHash},
        {"want of a later version", raw("\x01\x05\0\0\0"
                                        "CS\x02zz")},
        {"offer", raw("\x02\x4d\0\0\0"
                      "\x08\x07\x06\x05\0\0\0\0")
                      + kDigest + raw("\x03\0") + "CC0"},
        {"offer without a licence", raw("\x02\x4a\0\0\0"
                                        "\x01\0\0\0\0\0\0\0")
                                        + kDigest + raw("\0\0")},
        {"refusal", raw("\x03\x01\0\0\0\x02")},
        {"get", raw("\x04\x08\0\0\0"
                    "\x00\x00\x01\0\0\0\0\0")},
        {"chunk", raw("\x05\x04\0\0\0"
                      "\x00\x01\x02\xff")},
    };
}

} // namespace carina::test
