#include "engine/session/facts/utf8.h"

#include <cstddef>
#include <cstdint>

namespace carina
{

namespace
{

/// What the first byte of a character says: how many bytes follow, and which values the first of
/// them may take (RFC 3629, section 4); later ones take 80..BF.
struct Utf8Lead {
    std::size_t following;
    unsigned char lowest;
    unsigned char highest;
};

bool within(unsigned char byte, unsigned char lowest, unsigned char highest)
{
    return lowest <= byte && byte <= highest;
}

/// following is 0 for ASCII; lowest above highest for a byte that begins no character.
Utf8Lead readLead(unsigned char lead)
{
    if (within(lead, 0x00, 0x7f))
        return {0, 0x80, 0xbf};
    if (within(lead, 0xc2, 0xdf))
        return {1, 0x80, 0xbf};
    if (lead == 0xe0)
        return {2, 0xa0, 0xbf};
    if (lead == 0xed)
        return {2, 0x80, 0x9f};
    if (within(lead, 0xe1, 0xef))
        return {2, 0x80, 0xbf};
    if (lead == 0xf0)
        return {3, 0x90, 0xbf};
    if (within(lead, 0xf1, 0xf3))
        return {3, 0x80, 0xbf};
    if (lead == 0xf4)
        return {3, 0x80, 0x8f};
    return {1, 0xff, 0x00};
}

} // namespace

bool isUtf8(std::string_view bytes)
{
    std::size_t next = 0;
    while (next < bytes.size()) {
        Utf8Lead lead = readLead(static_cast<unsigned char>(bytes[next]));
        ++next;
        for (; lead.following > 0; --lead.following, ++next) {
            if (next == bytes.size())
                return false;
            if (!within(static_cast<unsigned char>(bytes[next]), lead.lowest, lead.highest))
                return false;
            lead.lowest = 0x80;
            lead.highest = 0xbf;
        }
    }
    return true;
}

} // namespace carina
