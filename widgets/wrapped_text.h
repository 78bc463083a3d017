#pragma once

#include <QStyledItemDelegate>

namespace carina
{

/// Writes the text of a cell whole, in as many lines as its column's width makes of it: between
/// words, and within a word that is longer than the column.
class WrappedTextDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    /// In one line where the option has no width.
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
};

} // namespace carina
