#pragma once

#include "engine/tracking/ndi/ndi_dialogue.h"

namespace carina
{

/// Brings a device at a serial port from whatever state to the best rate that both sides hold: it
/// is reset by a command at the rate after switching on; where that is not answered by a break; and
/// where that does not pass, as at many adapters, by a command at each rate. Then it is set to the
/// first of the rates that it accepts.
class NdiConnection
{
public:
    /// @param rates in bits a second, best first; of those that COMM can set
    /// @pre at least one rate; the dialogue outlives this.
    NdiConnection(std::vector<int> rates, NdiDialogue& dialogue);

    /// Queues the commands; `then` is called once the rate is set, and queues what follows.
    void connect(std::function<void()> then);
    /// The device does not answer at this rate: connect() tries the next one.
    void giveUpRate() { m_tried = (m_tried + 1) % m_rates.size(); }
    /// Begins with the best rate again.
    void startOver() { m_tried = 0; }

private:
    [[nodiscard]] std::vector<NdiStep> resetSteps();
    [[nodiscard]] std::vector<NdiStep> rateSteps();
    void dropRate(int rate);

    std::vector<int> m_rates;
    NdiDialogue& m_dialogue;
    std::function<void()> m_then;
    std::size_t m_tried = 0; ///< index of the rate
};

} // namespace carina
