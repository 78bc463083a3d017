#include "engine/tracking/ndi/ndi_client.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr int kRateAfterReset = 9600;
constexpr Duration kResetPatience = 1500ms;
constexpr Duration kResetCommandPatience = 600ms;
constexpr Duration kPatience = 2s;     // for a command of the set-up
constexpr Duration kInitPatience = 5s; // INIT tests the hardware
constexpr Duration kPosePatience = 250ms;
constexpr Duration kRateChange = 100ms; // that a device takes after COMM
constexpr Duration kBeforeRetry = 500ms;
constexpr std::size_t kMissedPosesBeforeRestart = 4;
constexpr std::size_t kDelaysKept = 256;
constexpr std::size_t kBlockBytes = 64; // of a definition, in PVWR
constexpr std::size_t kDefinitionBytes = 1024;
constexpr int kBitsPerByte = 10;

struct Rate {
    int bitsPerSecond;
    char digit; ///< of COMM
};
constexpr std::array kRates{Rate{9600, '0'},   Rate{14400, '1'},   Rate{19200, '2'},
                            Rate{38400, '3'},  Rate{57600, '4'},   Rate{115200, '5'},
                            Rate{921600, '6'}, Rate{1228739, '7'}, Rate{230400, 'A'}};

char rateDigit(int bitsPerSecond)
{
    const auto* rate = std::ranges::find(kRates, bitsPerSecond, &Rate::bitsPerSecond);
    CARINA_EXPECTS(rate != kRates.end());
    return rate->digit;
}

std::string inHexadecimal(std::size_t number, std::size_t digits)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text(digits, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number >>= 4U)
        *digit = kDigits[number & 0xFU];
    return text;
}

std::optional<std::uint16_t> fromHexadecimal(std::string_view digits)
{
    std::uint16_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, fault] = std::from_chars(digits.data(), end, number, 16);
    return fault == std::errc{} && stop == end && !digits.empty() ? std::optional{number}
                                                                  : std::nullopt;
}

/// The handles in a reply to PHSR: a count, and for each two digits and three of its status.
std::vector<std::uint16_t> handlesIn(const NdiReply& reply)
{
    constexpr std::size_t kEntry = 5;
    std::vector<std::uint16_t> handles;
    const std::string_view text{reply.bytes};
    const std::size_t count = fromHexadecimal(text.substr(0, 2)).value_or(0);
    for (std::size_t i = 0; i < count && text.size() >= 2 + (i + 1) * kEntry; ++i)
        if (const auto handle = fromHexadecimal(text.substr(2 + i * kEntry, 2)))
            handles.push_back(*handle);
    return handles;
}

bool isFine(const NdiReply& reply)
{
    return reply.bytes == "OKAY" || reply.bytes.starts_with("WARNING");
}

std::string whyRefused(const NdiReply& reply)
{
    const auto code = errorCode(reply);
    return code ? errorMeaning(*code) : "an answer that is not expected";
}

} // namespace

NdiClient::NdiClient(NdiClientSettings settings) : m_settings{std::move(settings)}
{
    CARINA_EXPECTS(!m_settings.tools.empty() && !m_settings.rates.empty());
}

void NdiClient::start(LocalTime now)
{
    m_now = now;
    m_rate = 0;
    begin();
}

/// From whatever state, but at the rate that is tried now.
void NdiClient::begin()
{
    m_reader.clear();
    m_steps.clear();
    m_deadline.reset();
    m_toolOf.clear();
    m_refused.clear();
    m_lastFrame.reset();
    m_delays.clear();
    m_missedPoses = 0;
    m_phase = Phase::Connecting;
    m_wake = m_now;
    if (!m_settings.isSerial) {
        queueSetUp();
        return;
    }
    queueFirst(resetSteps());
}

std::vector<NdiClient::Step> NdiClient::resetSteps()
{
    const auto onReset = [this](const NdiReply&) { takeReset(); };
    const auto goOn = [] {};
    std::vector<Step> steps;
    steps.push_back({.patience = kResetPatience,
                     .then = onReset,
                     .inVain = goOn,
                     .isReset = true,
                     .sendsBreak = true,
                     .rate = kRateAfterReset});
    std::vector<int> rates{kRateAfterReset};
    std::ranges::copy_if(m_settings.rates, std::back_inserter(rates),
                         [](int rate) { return rate != kRateAfterReset; });
    for (const int rate : rates)
        steps.push_back({.command = {"RESET"},
                         .patience = kResetCommandPatience,
                         .then = onReset,
                         .inVain = goOn,
                         .isReset = true,
                         .rate = rate});
    steps.back().inVain = {};
    return steps;
}

/// The device is at the rate after a reset now, whichever it was at.
void NdiClient::takeReset()
{
    m_steps.clear();
    m_steps.push_back({.patience = Duration{0}, .rate = kRateAfterReset});
    for (Step& step : rateSteps())
        m_steps.push_back(std::move(step));
    queueSetUp();
}

/// None where the rate that is tried is the one after a reset.
std::vector<NdiClient::Step> NdiClient::rateSteps()
{
    const int wanted = m_settings.rates[m_rate];
    if (wanted == kRateAfterReset)
        return {};
    // Eight bits, no parity, one stop bit, no handshake.
    Step ask{.command = {"COMM", std::string{rateDigit(wanted)} + "0000"}, .patience = kPatience};
    ask.then = [this, wanted](const NdiReply& reply) {
        if (isFine(reply))
            return queueFirst(
                {{.patience = kRateChange}, {.patience = Duration{0}, .rate = wanted}});
        std::erase(m_settings.rates, wanted);
        if (m_settings.rates.empty())
            m_settings.rates.push_back(kRateAfterReset);
        m_rate %= m_settings.rates.size();
        queueFirst(rateSteps());
    };
    std::vector<Step> steps;
    steps.push_back(std::move(ask));
    return steps;
}

void NdiClient::queueSetUp()
{
    Step init{.command = {"INIT"}, .patience = kInitPatience};
    init.then = [this](const NdiReply& reply) {
        if (!isFine(reply))
            return fallSilent(m_now, "it does not initialise: " + whyRefused(reply));
        m_phase = Phase::SettingUp;
    };
    // At a rate at which it does not answer the next one is tried.
    init.inVain = [this] {
        if (m_settings.isSerial)
            m_rate = (m_rate + 1) % m_settings.rates.size();
        fallSilent(m_now, "it does not answer");
    };
    m_steps.push_back(std::move(init));
    queue({"PHSR", "01"}, [this](const NdiReply& reply) {
        std::vector<Step> freeing;
        for (const std::uint16_t handle : handlesIn(reply))
            freeing.push_back(
                {.command = {"PHF", inHexadecimal(handle, 2)}, .patience = kPatience});
        queueFirst(std::move(freeing));
    });
    bool hasWired = false;
    for (std::size_t tool = 0; tool < m_settings.tools.size(); ++tool) {
        if (m_settings.tools[tool].definition)
            queueDefinition(tool);
        else
            hasWired = true;
    }
    if (hasWired)
        queueWiredTools();
    queue({"TSTART"}, [this](const NdiReply& reply) {
        if (!isFine(reply))
            return fallSilent(m_now, "it does not track: " + whyRefused(reply));
        m_phase = Phase::Tracking;
        queuePoses();
    });
}

void NdiClient::queueDefinition(std::size_t tool)
{
    queue({"PHRQ", "*********1****"}, [this, tool](const NdiReply& reply) {
        const auto handle = fromHexadecimal(reply.bytes);
        if (!handle || reply.bytes.size() != 2)
            return refuseTool(tool, reply);
        std::vector<Step> steps;
        const auto& bytes = m_settings.tools[tool].definition->bytes();
        for (std::size_t at = 0; at < kDefinitionBytes; at += kBlockBytes) {
            std::string block = inHexadecimal(*handle, 2) + inHexadecimal(at, 4);
            for (std::size_t i = at; i < at + kBlockBytes; ++i)
                block +=
                    inHexadecimal(i < bytes.size() ? std::to_integer<std::size_t>(bytes[i]) : 0, 2);
            steps.push_back({.command = {"PVWR", block}, .patience = kPatience});
        }
        queueFirst(std::move(steps));
        // Behind the blocks, before all that was queued.
        const std::size_t blocks = kDefinitionBytes / kBlockBytes;
        Step initialise{.command = {"PINIT", inHexadecimal(*handle, 2)}, .patience = kPatience};
        initialise.then = [this, tool, handle = *handle](const NdiReply& answer) {
            isFine(answer) ? queueEnabling(tool, handle) : refuseTool(tool, answer);
        };
        m_steps.insert(m_steps.begin() + std::ptrdiff_t(blocks), std::move(initialise));
    });
}

void NdiClient::queueWiredTools()
{
    queue({"PHSR", "02"}, [this](const NdiReply& reply) {
        std::vector<std::size_t> wired;
        for (std::size_t tool = 0; tool < m_settings.tools.size(); ++tool)
            if (!m_settings.tools[tool].definition)
                wired.push_back(tool);
        const std::vector<std::uint16_t> handles = handlesIn(reply);
        std::vector<Step> steps;
        for (std::size_t i = 0; i < wired.size(); ++i) {
            if (i >= handles.size()) {
                m_refused[wired[i]] = "nothing is plugged in for it";
                continue;
            }
            Step initialise{.command = {"PINIT", inHexadecimal(handles[i], 2)},
                            .patience = kPatience};
            initialise.then = [this, tool = wired[i], handle = handles[i]](const NdiReply& answer) {
                isFine(answer) ? queueEnabling(tool, handle) : refuseTool(tool, answer);
            };
            steps.push_back(std::move(initialise));
        }
        queueFirst(std::move(steps));
    });
}

void NdiClient::queueEnabling(std::size_t tool, std::uint16_t handle)
{
    Step enable{.command = {"PENA", inHexadecimal(handle, 2) + "D"}, .patience = kPatience};
    enable.then = [this, tool, handle](const NdiReply& reply) {
        if (isFine(reply))
            m_toolOf[handle] = tool;
        else
            refuseTool(tool, reply);
    };
    queueFirst({std::move(enable)});
}

void NdiClient::queuePoses()
{
    static const std::string kOptions = inHexadecimal(kNdiPoses | kNdiOutOfVolumeToo, 4);
    NdiCommand command{"BX", kOptions};
    if (m_settings.poses == NdiPoseReply::Tx)
        command.name = "TX";
    else if (m_settings.poses == NdiPoseReply::Bx2)
        command = {"BX2", "--6d=tools"};
    Step ask{.command = std::move(command), .patience = kPosePatience};
    ask.then = [this](const NdiReply& reply) { takePoses(reply, m_now); };
    ask.inVain = [this] {
        if (++m_missedPoses >= kMissedPosesBeforeRestart)
            fallSilent(m_now, "it does not answer");
        else
            queuePoses();
    };
    m_steps.push_back(std::move(ask));
}

void NdiClient::queue(NdiCommand command, std::function<void(const NdiReply&)> then)
{
    m_steps.push_back(
        {.command = std::move(command), .patience = kPatience, .then = std::move(then)});
}

void NdiClient::queueFirst(std::vector<Step> steps)
{
    m_steps.insert(m_steps.begin(), std::move_iterator{steps.begin()},
                   std::move_iterator{steps.end()});
}

void NdiClient::refuseTool(std::size_t tool, const NdiReply& reply)
{
    m_refused[tool] = whyRefused(reply);
}

void NdiClient::take(std::span<const std::byte> bytes, LocalTime now)
{
    m_now = now;
    m_replyBytes += bytes.size();
    m_reader.take(bytes);
    while (const auto reply = m_reader.next()) {
        if (*reply)
            takeReply(**reply, now);
        else
            ++m_damaged; // its step ends when its patience does
        m_replyBytes = 0;
    }
}

void NdiClient::takeReply(const NdiReply& reply, LocalTime now)
{
    const bool isReset = reply.bytes == "RESET";
    const bool waits = m_deadline && !m_steps.empty()
                       && (m_steps.front().isReset || !m_steps.front().command.name.empty());
    if (isReset && !(waits && m_steps.front().isReset)) {
        if (m_settings.isSerial && m_phase != Phase::Silent)
            begin(); // it was switched off and on
        return;
    }
    if (!waits || isReset != m_steps.front().isReset)
        return; // too late, or of nobody
    const Step step = std::move(m_steps.front());
    m_steps.pop_front();
    m_deadline.reset();
    m_wake = now;
    if (step.then)
        step.then(reply);
}

void NdiClient::takePoses(const NdiReply& reply, LocalTime now)
{
    m_missedPoses = 0;
    const auto code = errorCode(reply);
    if (code)
        return fallSilent(now, "it does not track: " + errorMeaning(*code));
    const auto body = std::as_bytes(std::span{reply.bytes});
    constexpr std::uint16_t kOptions = kNdiPoses | kNdiOutOfVolumeToo;
    const auto frame = m_settings.poses == NdiPoseReply::Tx   ? decodeTx(reply.bytes, kOptions)
                       : m_settings.poses == NdiPoseReply::Bx ? decodeBx(body, kOptions)
                                                              : decodeBx2(body);
    queuePoses();
    if (!frame) {
        ++m_damaged;
        return;
    }
    NdiMeasurement measured{exposureOf(*frame, now), {}};
    measured.tools.resize(m_settings.tools.size());
    std::optional<std::uint32_t> number;
    for (const NdiTool& tool : frame->tools) {
        const auto wanted = m_toolOf.find(tool.handle);
        if (wanted == m_toolOf.end() || tool.sight == NdiSight::Disabled
            || tool.sight == NdiSight::Unoccupied)
            continue;
        number = std::max(number.value_or(0), tool.frameNumber);
        measured.tools[wanted->second] = tool;
    }
    if (!number || number == m_lastFrame)
        return;
    m_lastFrame = number;
    m_measured.push_back(std::move(measured));
}

LocalTime NdiClient::exposureOf(const NdiFrame& frame, LocalTime arrived)
{
    const LocalTime sent =
        m_settings.isSerial
            ? arrived
                  - std::chrono::nanoseconds{std::int64_t(m_replyBytes) * kBitsPerByte
                                             * 1'000'000'000 / m_bitsPerSecond}
            : arrived;
    if (!frame.deviceTime)
        return sent;
    m_delays.push_back(sent.time_since_epoch() - *frame.deviceTime);
    if (m_delays.size() > kDelaysKept)
        m_delays.pop_front();
    return LocalTime{*frame.deviceTime + *std::ranges::min_element(m_delays)};
}

void NdiClient::fallSilent(LocalTime now, std::string why)
{
    m_silence = std::move(why);
    m_phase = Phase::Silent;
    m_steps.clear();
    m_deadline.reset();
    Step wait{.patience = kBeforeRetry};
    wait.inVain = [this] { begin(); };
    m_steps.push_back(std::move(wait));
    m_wake = now;
}

NdiPortAction NdiClient::advance(LocalTime now)
{
    m_now = now;
    NdiPortAction action;
    while (!m_steps.empty()) {
        if (m_deadline && now < *m_deadline) {
            m_wake = *m_deadline;
            return action;
        }
        if (m_deadline) { // in vain, or waited
            const Step step = std::move(m_steps.front());
            m_steps.pop_front();
            m_deadline.reset();
            m_reader.clear();
            m_replyBytes = 0;
            const bool asked = step.isReset || !step.command.name.empty();
            if (step.inVain)
                step.inVain();
            else if (asked)
                fallSilent(now, "it does not answer");
            continue;
        }
        const Step& step = m_steps.front();
        m_deadline = now + step.patience;
        if (step.rate) {
            action.rate = step.rate;
            m_bitsPerSecond = *step.rate;
        }
        action.sendBreak = action.sendBreak || step.sendsBreak;
        if (!step.command.name.empty())
            action.bytes += encoded(step.command);
    }
    m_wake = now + kBeforeRetry;
    return action;
}

std::vector<NdiMeasurement> NdiClient::takeMeasurements() { return std::exchange(m_measured, {}); }

std::string NdiClient::trouble() const
{
    if (m_phase == Phase::Silent)
        return m_silence;
    std::string text;
    for (const auto& [tool, why] : m_refused)
        text += (text.empty() ? "" : "; ") + m_settings.tools[tool].name + ": " + why;
    return text;
}

} // namespace carina
