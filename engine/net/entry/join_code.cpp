#include "engine/net/entry/join_code.h"

#include "engine/net/entry/access_key.h"

namespace carina
{
namespace
{

constexpr std::string_view kAlphabet = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
static_assert(kAlphabet.size() == 32);

char asShown(char typed)
{
    if (typed >= 'a' && typed <= 'z')
        typed = static_cast<char>(typed - 'a' + 'A');
    if (typed == 'I' || typed == 'L')
        return '1';
    return typed == 'O' ? '0' : typed;
}

} // namespace

JoinCode JoinCode::random()
{
    const AccessKey bits = randomKey(); // five bits of one byte for each character
    std::string characters;
    for (std::size_t i = 0; i < kCharacters; ++i)
        characters += kAlphabet[std::to_integer<std::size_t>(bits[i]) % kAlphabet.size()];
    return JoinCode{std::move(characters)};
}

Result<JoinCode> JoinCode::parse(std::string_view typed)
{
    std::string characters;
    for (const char c : typed) {
        if (c == '-' || c == ' ')
            continue;
        const char shown = asShown(c);
        if (kAlphabet.find(shown) == std::string_view::npos || characters.size() == kCharacters)
            return fail(Errc::WrongCode, "a code looks like 7KQ2M-X4TN9");
        characters += shown;
    }
    if (characters.size() != kCharacters)
        return fail(Errc::WrongCode, "a code has ten letters and digits");
    return JoinCode{std::move(characters)};
}

std::string JoinCode::text() const
{
    return m_characters.substr(0, kCharacters / 2) + '-' + m_characters.substr(kCharacters / 2);
}

} // namespace carina
