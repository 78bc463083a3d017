#include "widgets/theme/dark_theme.h"

#include "resources/resources.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

#include <algorithm>

namespace carina
{

namespace
{

constexpr double kLeastPointSize = 12.0;

QPalette darkPalette()
{
    const QColor window(30, 38, 46);
    const QColor base(22, 29, 36);
    const QColor text(226, 232, 238);
    const QColor accent(86, 168, 214);
    const QColor faint(132, 144, 156);
    QPalette palette(text, QColor(48, 59, 70), QColor(66, 80, 94), QColor(14, 18, 22),
                     QColor(70, 84, 98), text, QColor(255, 255, 255), base, window);
    palette.setColor(QPalette::AlternateBase, QColor(27, 35, 43));
    palette.setColor(QPalette::ToolTipBase, QColor(44, 54, 64));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::PlaceholderText, faint);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, QColor(10, 16, 22));
    palette.setColor(QPalette::Link, accent);
    palette.setColor(QPalette::Midlight, QColor(58, 71, 84));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faint);
    return palette;
}

} // namespace

void applyDarkTheme(QApplication& application)
{
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(darkPalette());
    QFont font = QApplication::font();
    font.setPointSizeF(std::max(kLeastPointSize, font.pointSizeF()));
    QApplication::setFont(font);
    application.setStyleSheet(QString::fromUtf8(resource("styles/dark.qss")));
}

} // namespace carina
