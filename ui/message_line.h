#pragma once

#include "widgets/plain_label.h"

namespace carina
{

/// A line with the last error or notice, which is also announced once to screen readers.
class MessageLine : public PlainLabel
{
    Q_OBJECT

public:
    using PlainLabel::PlainLabel;

    /// Shows a problem; an empty text clears it.
    void warn(const QString& problem);
    void confirm(const QString& notice);

private:
    void say(const QString& message);
};

} // namespace carina
