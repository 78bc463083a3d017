#pragma once

#include "engine/io/files/json_fields.h"

namespace carina
{

/// Texts of a site file that may be left out: an empty one is.
inline QString jsonWords(const std::string& text) { return QString::fromStdString(text); }

inline void insertText(QJsonObject& object, const char* key, const std::string& text)
{
    if (!text.empty())
        object.insert(QLatin1StringView{key}, jsonWords(text));
}

[[nodiscard]] inline std::string readText(JsonFields& fields, const char* key)
{
    return fields.has(key) ? fields.text(key) : std::string{};
}

} // namespace carina
