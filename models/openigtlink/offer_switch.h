#pragma once

#include "models/openigtlink/offer_giver.h"

#include <QObject>

namespace carina
{

/// Whether a program gives what it shows to programs of other makers, and where: off until somebody
/// switches it on.
class OfferSwitch : public QObject
{
    Q_OBJECT

public:
    using Shown = std::function<OfferGiver::Shown()>;

    /// @pre what `shown` uses outlives this.
    explicit OfferSwitch(Shown shown, QObject* parent = nullptr);

    /// Gives at this place from now on, and at none that it gave at before.
    /// @returns the errors of IgtlServer::listen; then it gives where it did before.
    [[nodiscard]] Result<void> begin(const IgtlPlace& place);
    void end();

    [[nodiscard]] bool isOn() const { return m_giver != nullptr; }
    /// Whether other computers can reach it.
    [[nodiscard]] bool isOpen() const { return isOn() && !m_giver->place().isLoopback(); }
    /// Where it gives, with the port that was found where any was asked for. @pre isOn()
    [[nodiscard]] const IgtlPlace& place() const { return m_giver->place(); }
    /// How many programs read along.
    [[nodiscard]] int clients() const { return isOn() ? m_giver->clients() : 0; }

    /// Where it gives, to whom, and how many read along, as sentences; empty while it is off.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    /// It was switched on or off. How many read along is to be looked at.
    void changed();

private:
    Shown m_shown;
    std::unique_ptr<OfferGiver> m_giver; ///< null while it is off
};

} // namespace carina
