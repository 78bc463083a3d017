#include "engine/tracking/ndi/ndi_connection.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr int kRateAfterReset = 9600;
constexpr Duration kBreakPatience = 1500ms;
constexpr Duration kFirstResetPatience = 300ms;
constexpr Duration kResetCommandPatience = 600ms;
constexpr Duration kRatePatience = 2s;
constexpr int kRepeats = 3;                    // of a command that arrived damaged
constexpr std::uint8_t kDamagedCommand = 0x04; // ERROR04
constexpr Duration kRateChange = 100ms;        // that a device takes after COMM

struct Rate {
    int bitsPerSecond;
    char digit; ///< of COMM
};
// COMM also has 14400 and 1228739, which usual adapters do not hold.
constexpr std::array kRates{Rate{9600, '0'},  Rate{19200, '2'},  Rate{38400, '3'},
                            Rate{57600, '4'}, Rate{115200, '5'}, Rate{230400, 'A'},
                            Rate{921600, '6'}};

char rateDigit(int bitsPerSecond)
{
    const auto* rate = std::ranges::find(kRates, bitsPerSecond, &Rate::bitsPerSecond);
    CARINA_EXPECTS(rate != kRates.end());
    return rate->digit;
}

} // namespace

NdiConnection::NdiConnection(std::vector<int> rates, NdiDialogue& dialogue)
    : m_rates{std::move(rates)}, m_dialogue{dialogue}
{
    CARINA_EXPECTS(!m_rates.empty());
}

void NdiConnection::connect(std::function<void()> then, std::optional<NdiStep> between)
{
    m_then = std::move(then);
    m_refused.clear(); // it may be another device
    m_dialogue.queueFirst(resetSteps(between));
}

std::vector<NdiStep> NdiConnection::resetSteps(const std::optional<NdiStep>& between)
{
    // The device is at the rate after a reset now, whichever it was at.
    const auto onReset = [this](const NdiReply&) {
        m_dialogue.dropSteps();
        m_dialogue.queue({.patience = Duration{0}, .rate = kRateAfterReset});
        for (NdiStep& step : rateSteps())
            m_dialogue.queue(std::move(step));
        m_then();
    };
    const auto goOn = [] {};
    std::vector<NdiStep> steps;
    const auto addBetween = [&] {
        if (between)
            steps.push_back(*between);
    };
    // A device that was just switched on is at this rate, and many adapters pass no break.
    steps.push_back({.command = {"RESET"},
                     .patience = kFirstResetPatience,
                     .then = onReset,
                     .inVain = goOn,
                     .isReset = true,
                     .rate = kRateAfterReset});
    addBetween();
    steps.push_back({.patience = kBreakPatience,
                     .then = onReset,
                     .inVain = goOn,
                     .isReset = true,
                     .sendsBreak = true,
                     .rate = kRateAfterReset});
    std::vector<int> rates{kRateAfterReset};
    std::ranges::copy_if(m_rates, std::back_inserter(rates),
                         [](int rate) { return rate != kRateAfterReset; });
    for (const int rate : rates) {
        addBetween();
        steps.push_back({.command = {"RESET"},
                         .patience = kResetCommandPatience,
                         .then = onReset,
                         .inVain = goOn,
                         .isReset = true,
                         .rate = rate});
    }
    steps.back().inVain = {};
    return steps;
}

/// None where the rate that is tried is the one after a reset.
std::vector<NdiStep> NdiConnection::rateSteps()
{
    m_rate = bestRate();
    std::vector<NdiStep> steps;
    if (m_rate == kRateAfterReset)
        return steps;
    if (m_holdsRate && !m_holdsRate(m_rate)) {
        m_refused.insert(m_rate);
        return rateSteps();
    }
    steps.push_back(askingFor(m_rate, kRepeats));
    return steps;
}

NdiStep NdiConnection::askingFor(int rate, int repeats)
{
    // Eight bits, no parity, one stop bit, no handshake.
    NdiStep ask{.command = {"COMM", std::string{rateDigit(rate)} + "0000"},
                .patience = kRatePatience};
    ask.then = [this, rate, repeats](const NdiReply& reply) {
        if (isFine(reply))
            return m_dialogue.queueFirst(
                {{.patience = kRateChange}, {.patience = Duration{0}, .rate = rate}});
        if (errorCode(reply) == kDamagedCommand && repeats > 0)
            return m_dialogue.queueFirst({askingFor(rate, repeats - 1)});
        m_refused.insert(rate);
        m_dialogue.queueFirst(rateSteps());
    };
    return ask;
}

/// Once all were in vain, all are tried again.
int NdiConnection::bestRate()
{
    const auto best = [this] {
        return std::ranges::find_if(m_rates, [this](int rate) {
            return !m_refused.contains(rate) && !m_inVain.contains(rate);
        });
    };
    auto rate = best();
    if (rate == m_rates.end()) {
        m_inVain.clear();
        rate = best();
    }
    return rate == m_rates.end() ? kRateAfterReset : *rate;
}

void NdiConnection::giveUpRate()
{
    m_inVain.insert(m_rate);
    m_works = false;
}

void NdiConnection::startOver(HoldsRate holdsRate)
{
    m_holdsRate = std::move(holdsRate);
    if (!m_works)
        m_inVain.clear();
}

} // namespace carina
