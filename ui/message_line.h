#pragma once

#include <QLabel>

namespace carina
{

/// What went wrong last, or was done last beside what is shown: to be seen, and to be heard once by
/// what reads the screen aloud.
class MessageLine : public QLabel
{
    Q_OBJECT

public:
    using QLabel::QLabel;

    /// Nothing where there is no problem.
    void warn(const QString& problem);
    void confirm(const QString& notice);

private:
    void say(const QString& message);
};

} // namespace carina
