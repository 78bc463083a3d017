#pragma once

#include "ui/message_line.h"

namespace carina
{

/// Says why a number that was typed was refused, until one is taken. Where there is nothing to say
/// it takes no room.
class RefusalLine : public MessageLine
{
    Q_OBJECT

public:
    explicit RefusalLine(QWidget* parent = nullptr);

    /// @param box a CheckedSpinBox or CheckedDoubleSpinBox
    template <class Box> void watch(const Box& box)
    {
        connect(&box, &Box::refused, this, &RefusalLine::tell);
        connect(&box, &Box::valueChanged, this, &RefusalLine::forget);
    }

private:
    void tell(const QString& why);
    void forget();
};

} // namespace carina
