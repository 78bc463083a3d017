#include "widgets/checked_spin_box.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QToolTip>

#include <optional>

namespace carina
{
namespace
{

constexpr qsizetype kMostDigits = 12;

/// What is typed between prefix and suffix.
template <class Box> QString typedIn(const Box& box, QString text)
{
    if (text.startsWith(box.prefix()))
        text.remove(0, box.prefix().size());
    if (text.endsWith(box.suffix()))
        text.chop(box.suffix().size());
    return text.trimmed();
}

/// A number that is typed, whatever its range.
template <class Box> std::optional<double> numberIn(const Box& box, const QString& text)
{
    bool isNumber = false;
    const QString typed = typedIn(box, text);
    const double number = box.locale().toDouble(typed, &isNumber);
    return isNumber && typed.size() <= kMostDigits ? std::optional{number} : std::nullopt;
}

template <class Box>
QValidator::State stateOf(const Box& box, const QString& text, QValidator::State usual)
{
    return usual == QValidator::Invalid && numberIn(box, text) ? QValidator::Intermediate : usual;
}

/// Puts the value back into the text. @returns why, where a number was refused.
/// @param below what else to do where it was below the range; may be empty
template <class Box>
QString putBack(const Box& box, const QString& value, QString& text, const QString& below = {})
{
    const auto number = numberIn(box, text);
    const QString typed = typedIn(box, text);
    text = box.prefix() + value + box.suffix();
    if (!number || (*number >= box.minimum() && *number <= box.maximum()))
        return {};
    const QString why =
        QCoreApplication::translate("carina::CheckedSpinBox",
                                    "%1 is outside the range: enter %2 to %3%4. The value stays "
                                    "%5.")
            .arg(typed, box.locale().toString(box.minimum()), box.locale().toString(box.maximum()),
                 box.suffix(), text);
    return below.isEmpty() || *number > box.maximum() ? why : why + QLatin1Char{' '} + below;
}

/// Whether something else is in the field than its value. @param value as text
template <class Box> bool isHalfTyped(const Box& box, const QString& value)
{
    const bool isSpecial = box.value() == box.minimum() && !box.specialValueText().isEmpty();
    return box.text() != (isSpecial ? box.specialValueText() : box.prefix() + value + box.suffix());
}

/// With these keys a field puts back what was typed before, also before it was entered.
bool isKeyOfUndo(const QEvent& event)
{
    if (event.type() != QEvent::ShortcutOverride && event.type() != QEvent::KeyPress)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

void showBeneath(const QWidget& box, const QString& why)
{
    QToolTip::showText(box.mapToGlobal(box.rect().bottomLeft()), why);
}

} // namespace

CheckedSpinBox::CheckedSpinBox(QWidget* parent) : QSpinBox{parent} { setKeyboardTracking(false); }

bool CheckedSpinBox::event(QEvent* event)
{
    if (!isKeyOfUndo(*event) || isHalfTyped(*this, textFromValue(value())))
        return QSpinBox::event(event);
    event->ignore();
    return false;
}

QValidator::State CheckedSpinBox::validate(QString& input, int& position) const
{
    return stateOf(*this, input, QSpinBox::validate(input, position));
}

void CheckedSpinBox::fixup(QString& input) const
{
    if (const QString why = putBack(*this, textFromValue(value()), input, m_below);
        !why.isEmpty()) {
        showBeneath(*this, why);
        Q_EMIT refused(why);
    }
}

CheckedDoubleSpinBox::CheckedDoubleSpinBox(QWidget* parent) : QDoubleSpinBox{parent}
{
    setKeyboardTracking(false);
}

bool CheckedDoubleSpinBox::event(QEvent* event)
{
    if (!isKeyOfUndo(*event) || isHalfTyped(*this, textFromValue(value())))
        return QDoubleSpinBox::event(event);
    event->ignore();
    return false;
}

QValidator::State CheckedDoubleSpinBox::validate(QString& input, int& position) const
{
    return stateOf(*this, input, QDoubleSpinBox::validate(input, position));
}

void CheckedDoubleSpinBox::fixup(QString& input) const
{
    if (const QString why = putBack(*this, textFromValue(value()), input); !why.isEmpty()) {
        showBeneath(*this, why);
        Q_EMIT refused(why);
    }
}

} // namespace carina
