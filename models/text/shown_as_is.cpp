#include "models/text/shown_as_is.h"

namespace carina
{

QString shownAsIs(const QString& text)
{
    const bool mayBeRich = text.contains(QLatin1Char('<')) || text.contains(QStringLiteral("&lt;"));
    return mayBeRich ? QStringLiteral("<span style='white-space:pre-wrap'>") + text.toHtmlEscaped()
                           + QStringLiteral("</span>")
                     : text;
}

} // namespace carina
