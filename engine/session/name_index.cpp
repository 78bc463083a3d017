#include "engine/session/name_index.h"

#include "engine/session/facts/plain_name.h"

namespace carina
{

void NameIndex::add(const std::string& name)
{
    const NameLook look = lookOf(name);
    m_ofFolded.emplace(look.ofFolded, name);
    m_folded.emplace(look.folded, name);
}

const std::string* NameIndex::alike(const std::string& name) const
{
    const NameLook look = lookOf(name);
    if (const auto known = m_ofFolded.find(look.ofFolded); known != m_ofFolded.end())
        return &known->second;
    const auto known = m_folded.find(look.folded);
    return known == m_folded.end() ? nullptr : &known->second;
}

} // namespace carina
