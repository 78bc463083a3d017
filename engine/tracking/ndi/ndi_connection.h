#pragma once

#include "engine/tracking/ndi/ndi_dialogue.h"

#include <set>

namespace carina
{

/// Whether the host's port can be set to a rate, bits a second.
using HoldsRate = std::function<bool(int rate)>;

/// Brings a device at a serial port from whatever state to the best rate that both sides hold: it
/// is reset by a command at the rate after switching on; where that is not answered by a break; and
/// where that does not pass, as at many adapters, by a command at each rate. Then it is set to the
/// first of the rates that the host's port holds and the device accepts. What another device
/// refused before, or one that did not understand, does not matter. A rate at which the device did
/// not answer is passed over, also after the port was opened anew, as long as another one works.
class NdiConnection
{
public:
    /// @param rates in bits a second, best first; of those that COMM can set
    /// @pre at least one rate; the dialogue outlives this.
    NdiConnection(std::vector<int> rates, NdiDialogue& dialogue);

    /// Queues the commands; `then` is called once the rate is set, and queues what follows.
    /// @param between asked at the present rate between the resets, of a device that may still be
    ///        in its state
    void connect(std::function<void()> then, std::optional<NdiStep> between = {});
    /// That is tried, or works.
    [[nodiscard]] int rate() const { return m_rate; }
    /// The device does not answer at this rate: connect() tries the next one.
    void giveUpRate();
    /// The device answers at this rate.
    void keepRate() { m_works = true; }
    /// The port was opened.
    void startOver(HoldsRate holdsRate);

private:
    [[nodiscard]] std::vector<NdiStep> resetSteps(const std::optional<NdiStep>& between);
    [[nodiscard]] std::vector<NdiStep> rateSteps();
    [[nodiscard]] NdiStep askingFor(int rate, int repeats);
    [[nodiscard]] int bestRate();

    std::vector<int> m_rates;
    NdiDialogue& m_dialogue;
    std::function<void()> m_then;
    HoldsRate m_holdsRate;
    int m_rate = 0;          ///< that is tried
    std::set<int> m_refused; ///< rates, of this device or by the host
    std::set<int> m_inVain;  ///< rates that were accepted, but nothing passes
    bool m_works = false;    ///< a rate, since the last that was in vain
};

} // namespace carina
