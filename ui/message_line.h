#pragma once

#include <QLabel>

namespace carina
{

/// A line with the last error or notice, which is also announced once to screen readers.
class MessageLine : public QLabel
{
    Q_OBJECT

public:
    using QLabel::QLabel;

    /// Shows a problem; an empty text clears it.
    void warn(const QString& problem);
    void confirm(const QString& notice);

private:
    void say(const QString& message);
};

} // namespace carina
