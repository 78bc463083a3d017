#include "engine/session/facts/plain_name.h"

#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/uspoof.h>

#include <map>
#include <string>

namespace carina
{
namespace
{

bool isUnseen(UChar32 character)
{
    constexpr std::uint32_t kUnseen = U_GC_CC_MASK | U_GC_CF_MASK | U_GC_CS_MASK | U_GC_CO_MASK
                                      | U_GC_CN_MASK | U_GC_ZL_MASK | U_GC_ZP_MASK;
    return (U_MASK(u_charType(character)) & kUnseen) != 0
           || u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT);
}

const USpoofChecker* checker()
{
    static USpoofChecker* const only = [] {
        UErrorCode status = U_ZERO_ERROR;
        return uspoof_open(&status);
    }();
    return only;
}

icu::UnicodeString unicode(std::string_view utf8)
{
    return icu::UnicodeString::fromUTF8({utf8.data(), static_cast<std::int32_t>(utf8.size())});
}

icu::UnicodeString withoutBlanks(std::string_view utf8)
{
    icu::UnicodeString name = unicode(utf8);
    for (std::int32_t i = 0; i < name.length();)
        if (u_isUWhiteSpace(name.charAt(i)))
            name.remove(i, 1);
        else
            ++i;
    return name;
}

icu::UnicodeString folded(icu::UnicodeString name) { return name.foldCase(); }

icu::UnicodeString skeletonOf(const icu::UnicodeString& name)
{
    icu::UnicodeString skeleton;
    UErrorCode status = U_ZERO_ERROR;
    uspoof_getSkeletonUnicodeString(checker(), 0, name, skeleton, &status);
    return U_SUCCESS(status) ? skeleton : name;
}

struct Skeletons {
    icu::UnicodeString ofFolded; ///< skeleton of the name in one case
    icu::UnicodeString folded;   ///< its skeleton in one case
};

/// Kept, because a newcomer is compared with everybody there ever was.
const Skeletons& skeletonsOf(std::string_view utf8)
{
    constexpr std::size_t kMostKept = 4096;
    thread_local std::map<std::string, Skeletons, std::less<>> kept;
    if (const auto known = kept.find(utf8); known != kept.end())
        return known->second;
    if (kept.size() >= kMostKept)
        kept.clear();
    const icu::UnicodeString name = withoutBlanks(utf8);
    return kept
        .emplace(std::string{utf8}, Skeletons{skeletonOf(folded(name)), folded(skeletonOf(name))})
        .first->second;
}

} // namespace

Result<void> checkName(std::string_view utf8)
{
    const icu::UnicodeString name = unicode(utf8);
    const std::int32_t characters = name.countChar32();
    if (characters == 0 || characters > kLongestName)
        return fail(Errc::NameUnclear, "1 to " + std::to_string(kLongestName) + " characters");
    for (std::int32_t i = 0; i < name.length(); i = name.moveIndex32(i, 1))
        if (isUnseen(name.char32At(i)))
            return fail(Errc::NameUnclear);
    const bool isPadded = u_isUWhiteSpace(name.char32At(0))
                          || u_isUWhiteSpace(name.char32At(name.moveIndex32(name.length(), -1)));
    return isPadded ? fail(Errc::NameUnclear) : Result<void>{};
}

bool lookAlike(std::string_view utf8, std::string_view otherUtf8)
{
    const Skeletons name = skeletonsOf(utf8);
    const Skeletons& other = skeletonsOf(otherUtf8);
    return name.ofFolded == other.ofFolded || name.folded == other.folded;
}

} // namespace carina
