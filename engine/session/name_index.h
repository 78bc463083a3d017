#pragma once

#include <map>
#include <string>

namespace carina
{

/// The names of a session by how they look (lookOf), so that a newcomer is compared with everybody
/// there ever was at the cost of two look-ups.
class NameIndex
{
public:
    void add(const std::string& name);
    /// The first name that looks like this one; nullptr where none does.
    [[nodiscard]] const std::string* alike(const std::string& name) const;

private:
    std::map<std::string, std::string> m_ofFolded; // by NameLook::ofFolded
    std::map<std::string, std::string> m_folded;   // by NameLook::folded
};

} // namespace carina
