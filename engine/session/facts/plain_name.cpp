#include "engine/session/facts/plain_name.h"

#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/uspoof.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace carina
{
namespace
{

/// Drawn as blanks, though they are none by their category: the Braille pattern without dots, a
/// note head that is not drawn, a filler of Khitan, and what stands for what is not there.
bool isBlankSymbol(UChar32 character)
{
    constexpr std::array<UChar32, 5> kBlanks{0x2800, 0x1D159, 0x16FE4, 0xFFFC, 0xFFFD};
    return std::ranges::find(kBlanks, character) != kBlanks.end();
}

bool isBlank(UChar32 character) { return u_isUWhiteSpace(character) || isBlankSymbol(character); }

bool isMark(UChar32 character)
{
    return (U_MASK(u_charType(character)) & (U_GC_MN_MASK | U_GC_MC_MASK | U_GC_ME_MASK)) != 0;
}

bool isUnseen(UChar32 character)
{
    constexpr std::uint32_t kUnseen = U_GC_CC_MASK | U_GC_CF_MASK | U_GC_CS_MASK | U_GC_CO_MASK
                                      | U_GC_CN_MASK | U_GC_ZL_MASK | U_GC_ZP_MASK;
    return (U_MASK(u_charType(character)) & kUnseen) != 0
           || u_hasBinaryProperty(character, UCHAR_DEFAULT_IGNORABLE_CODE_POINT)
           || isBlankSymbol(character);
}

/// Whether each mark stands behind a letter, and few behind one.
bool hasPlainMarks(const icu::UnicodeString& name)
{
    int marks = kMostMarks; // none at the beginning
    for (std::int32_t i = 0; i < name.length(); i = name.moveIndex32(i, 1)) {
        const UChar32 character = name.char32At(i);
        const bool takesMarks = !isMark(character) && !isBlank(character);
        marks = isMark(character) ? marks + 1 : takesMarks ? 0 : kMostMarks;
        if (isMark(character) && marks > kMostMarks)
            return false;
    }
    return true;
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
    const icu::UnicodeString name = unicode(utf8);
    icu::UnicodeString seen;
    for (std::int32_t i = 0; i < name.length(); i = name.moveIndex32(i, 1))
        if (!isBlank(name.char32At(i)))
            seen.append(name.char32At(i));
    return seen;
}

icu::UnicodeString folded(icu::UnicodeString name) { return name.foldCase(); }

icu::UnicodeString skeletonOf(const icu::UnicodeString& name)
{
    icu::UnicodeString skeleton;
    UErrorCode status = U_ZERO_ERROR;
    uspoof_getSkeletonUnicodeString(checker(), 0, name, skeleton, &status);
    return U_SUCCESS(status) ? skeleton : name;
}

std::string utf8Of(const icu::UnicodeString& text)
{
    std::string utf8;
    return text.toUTF8String(utf8);
}

/// Kept, because a name is looked at each time that its program says Hello.
const NameLook& keptLookOf(std::string_view utf8)
{
    constexpr std::size_t kMostKept = 4096;
    thread_local std::map<std::string, NameLook, std::less<>> kept;
    if (const auto known = kept.find(utf8); known != kept.end())
        return known->second;
    if (kept.size() >= kMostKept)
        kept.clear();
    const icu::UnicodeString name = withoutBlanks(utf8);
    return kept
        .emplace(std::string{utf8},
                 NameLook{utf8Of(skeletonOf(folded(name))), utf8Of(folded(skeletonOf(name)))})
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
    if (!hasPlainMarks(name))
        return fail(Errc::NameUnclear);
    const bool isPadded = u_isUWhiteSpace(name.char32At(0))
                          || u_isUWhiteSpace(name.char32At(name.moveIndex32(name.length(), -1)));
    return isPadded ? fail(Errc::NameUnclear) : Result<void>{};
}

NameLook lookOf(std::string_view utf8) { return keptLookOf(utf8); }

bool lookAlike(std::string_view utf8, std::string_view otherUtf8)
{
    const NameLook name = keptLookOf(utf8); // a copy: the next may forget it
    const NameLook& other = keptLookOf(otherUtf8);
    return name.ofFolded == other.ofFolded || name.folded == other.folded;
}

} // namespace carina
