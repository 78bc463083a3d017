#pragma once

#include <QRect>
#include <QString>
#include <QStyledItemDelegate>

namespace carina
{

/// A delegate that draws a number of a table as a bar, with the number and its unit beside it.
/// Cells without a number in kValueRole are drawn as usual.
class ResidualBar : public QStyledItemDelegate
{
    Q_OBJECT

public:
    static constexpr int kValueRole = Qt::UserRole;

    /// The layout of one cell, in pixels.
    struct Bar {
        QRect frame;  ///< of a bar at full scale
        QRect filled; ///< from the left of the frame
        QRect words;  ///< to the right of the frame
        QString text; ///< such as "0.3 mm"
    };

    explicit ResidualBar(QString unit, QObject* parent = nullptr);

    /// The number at which the bar fills the frame; larger ones fill it, too.
    /// @pre above zero
    void setFullScale(double value);

    [[nodiscard]] Bar bar(const QStyleOptionViewItem& option, double value) const;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;

private:
    [[nodiscard]] QString textOf(double value) const;

    QString m_unit;
    double m_fullScale = 1.0;
};

} // namespace carina
