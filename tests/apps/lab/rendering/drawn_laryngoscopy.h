#pragma once

#include "apps/lab/commands.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonObject>
#include <QStringList>

namespace carina::drawn_laryngoscopy
{

inline constexpr QSize kSize{320, 240};

/// A whole laryngoscopy of the adult, in five pictures of kSize.
inline QJsonObject drawn(const QString& folder, const QStringList& more = {})
{
    const auto object =
        lab::renderCommand().run(QStringList{QStringLiteral("--laryngoscopy"), folder,
                                             QStringLiteral("--size"), QStringLiteral("320x240")}
                                 + more);
    if (!object)
        qWarning("%s", object.error().detail.c_str());
    return object.value_or(QJsonObject{});
}

inline qint64 pixels(const QJsonValue& picture, const char* structure)
{
    return picture[QStringLiteral("visible_pixels")][QLatin1StringView{structure}].toInteger();
}

inline QString grade(const QJsonValue& picture)
{
    return picture[QStringLiteral("cormack_lehane")].toString();
}

} // namespace carina::drawn_laryngoscopy
