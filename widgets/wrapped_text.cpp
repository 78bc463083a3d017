#include "widgets/wrapped_text.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>

namespace carina
{
namespace
{

const QStyle& styleOf(const QStyleOptionViewItem& option)
{
    return option.widget ? *option.widget->style() : *QApplication::style();
}

/// Beside the text, as the style has it for any cell.
int textMargin(const QStyleOptionViewItem& option)
{
    return styleOf(option).pixelMetric(QStyle::PM_FocusFrameHMargin, &option, option.widget) + 1;
}

/// @returns its height
double layOutIn(QTextLayout& text, double width)
{
    QTextOption wrapping;
    wrapping.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    text.setTextOption(wrapping);
    double height = 0.0;
    text.beginLayout();
    for (QTextLine line = text.createLine(); line.isValid(); line = text.createLine()) {
        line.setLineWidth(width);
        line.setPosition({0.0, height});
        height += line.height();
    }
    text.endLayout();
    return height;
}

QPalette::ColorGroup groupOf(const QStyleOptionViewItem& option)
{
    if (!option.state.testFlag(QStyle::State_Enabled))
        return QPalette::Disabled;
    return option.state.testFlag(QStyle::State_Active) ? QPalette::Normal : QPalette::Inactive;
}

} // namespace

void WrappedTextDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                const QModelIndex& index) const
{
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    QTextLayout text{cell.text, cell.font};
    cell.text.clear(); // the style draws what lies behind it
    styleOf(option).drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
    const int margin = textMargin(cell);
    const QRect room = cell.rect.adjusted(margin, 0, -margin, 0);
    const double height = layOutIn(text, room.width());
    const bool isSelected = cell.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setPen(
        cell.palette.color(groupOf(cell), isSelected ? QPalette::HighlightedText : QPalette::Text));
    text.draw(painter, {double(room.x()), room.y() + 0.5 * (room.height() - height)});
    painter->restore();
}

QSize WrappedTextDelegate::sizeHint(const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const
{
    QStyleOptionViewItem cell = option;
    cell.rect = {};
    cell.features.setFlag(QStyleOptionViewItem::WrapText, false);
    const QSize inOneLine = QStyledItemDelegate::sizeHint(cell, index);
    const int width = option.rect.width() - 2 * textMargin(option);
    if (width <= 0)
        return inOneLine;
    initStyleOption(&cell, index);
    QTextLayout text{cell.text, cell.font};
    const double wrapped = layOutIn(text, width);
    const double line = text.lineAt(0).height();
    return {option.rect.width(), inOneLine.height() + qRound(wrapped - line)};
}

} // namespace carina
