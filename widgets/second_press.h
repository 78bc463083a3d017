#pragma once

#include <QTimer>

#include <chrono>

namespace carina
{

/// What cannot be taken back is asked for by one press and done by a second one, a few seconds
/// later at most. A press that follows another at once does nothing, so that a double click, or a
/// key that is held, only asks.
class SecondPress : public QObject
{
    Q_OBJECT

public:
    /// Between two presses that both count.
    static constexpr std::chrono::milliseconds kLeastPause{700};

    explicit SecondPress(QObject* parent = nullptr);

    [[nodiscard]] bool isAsked() const { return m_asked.isActive(); }
    void press();
    /// Whoever presses next asks anew.
    void forget();

Q_SIGNALS:
    void confirmed();
    /// isAsked() changed.
    void changed();

private:
    QTimer m_asked; ///< for how long the second press is waited for
    QTimer m_pause; ///< in which a press does not count
};

} // namespace carina
