#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace carina
{

// Boxes for numbers that are typed: one outside the range can be typed as it is, and is refused
// with the range as it is entered, where Qt's own would keep the digits that fit. The value then
// stays; it changes as a number is entered, not with each digit. The key of undo takes back typing
// as long as a number is half typed; else it is left to the window.

/// A box for whole numbers.
class CheckedSpinBox : public QSpinBox
{
    Q_OBJECT

public:
    explicit CheckedSpinBox(QWidget* parent = nullptr);

    /// A sentence on what else to do, which is said where a number below the range is refused.
    void adviseBelow(const QString& advice) { m_below = advice; }

    [[nodiscard]] QValidator::State validate(QString& input, int& position) const override;
    void fixup(QString& input) const override;

    bool event(QEvent* event) override;

Q_SIGNALS:
    /// A number was refused; one sentence with the range and its unit.
    void refused(const QString& why) const;

private:
    QString m_below;
};

/// A box for numbers with decimals.
class CheckedDoubleSpinBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit CheckedDoubleSpinBox(QWidget* parent = nullptr);

    [[nodiscard]] QValidator::State validate(QString& input, int& position) const override;
    void fixup(QString& input) const override;

    bool event(QEvent* event) override;

Q_SIGNALS:
    /// A number was refused; one sentence with the range and its unit.
    void refused(const QString& why) const;
};

} // namespace carina
