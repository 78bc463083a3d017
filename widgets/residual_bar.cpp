#include "widgets/residual_bar.h"

#include "engine/core/expects.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kGap = 8;         ///< pixels around frame and words
constexpr int kLeastFrame = 60; ///< pixels, wide
constexpr double kWidestNumber = 88.8;

} // namespace

ResidualBar::ResidualBar(QString unit, QObject* parent)
    : QStyledItemDelegate{parent}, m_unit{std::move(unit)}
{
}

void ResidualBar::setFullScale(double value)
{
    CARINA_EXPECTS(value > 0.0);
    m_fullScale = value;
}

QString ResidualBar::textOf(double value) const
{
    return QStringLiteral("%1 %2").arg(value, 0, 'f', 1).arg(m_unit);
}

ResidualBar::Bar ResidualBar::bar(const QStyleOptionViewItem& option, double value) const
{
    Bar bar;
    bar.text = textOf(value);
    const QRect inside = option.rect.adjusted(kGap, 0, -kGap, 0);
    const int words = option.fontMetrics.horizontalAdvance(textOf(kWidestNumber));
    bar.words = inside.adjusted(std::max(0, inside.width() - words), 0, 0, 0);
    const int height = option.fontMetrics.ascent();
    bar.frame = {inside.left(), inside.center().y() - height / 2,
                 std::max(0, bar.words.left() - kGap - inside.left()), height};
    bar.filled = bar.frame;
    bar.filled.setWidth(qRound(std::clamp(value / m_fullScale, 0.0, 1.0) * bar.frame.width()));
    return bar;
}

void ResidualBar::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const
{
    bool isNumber = false;
    const double value = index.data(kValueRole).toDouble(&isNumber);
    if (!isNumber) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    cell.text.clear();
    const QStyle* style = cell.widget ? cell.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);

    const bool selected = cell.state.testFlag(QStyle::State_Selected);
    const QPalette& palette = cell.palette;
    const QColor ink = palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    const Bar drawn = bar(cell, value);
    painter->save();
    painter->fillRect(drawn.filled, selected ? ink : palette.color(QPalette::Highlight));
    painter->setPen(selected ? ink : palette.color(QPalette::Mid));
    painter->drawRect(drawn.frame.adjusted(0, 0, -1, -1));
    painter->setPen(ink);
    painter->setFont(cell.font);
    painter->drawText(drawn.words, Qt::AlignRight | Qt::AlignVCenter, drawn.text);
    painter->restore();
}

QSize ResidualBar::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const int words = option.fontMetrics.horizontalAdvance(textOf(kWidestNumber));
    return QStyledItemDelegate::sizeHint(option, index)
        .expandedTo({kLeastFrame + words + 3 * kGap, 0});
}

} // namespace carina
