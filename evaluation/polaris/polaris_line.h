#pragma once

#include "engine/core/result.h"
#include "evaluation/polaris/polaris_device.h"

#include <filesystem>

namespace carina
{

/// What was said over a line.
struct PolarisTraffic {
    std::size_t bytesReceived = 0;
    std::size_t replies = 0;
    std::size_t bytesSent = 0;
};

/// Serves a PolarisDevice to a program: at a pseudo-terminal, whose rate is the one that the
/// program sets, or at a TCP port of the loopback address.
class PolarisLine
{
public:
    /// A pseudo-terminal, with a link to it at `link`, which is replaced.
    /// @returns FileUnwritable
    [[nodiscard]] static Result<PolarisLine> terminal(const std::filesystem::path& link);
    /// @returns AddressInUse
    [[nodiscard]] static Result<PolarisLine> tcp(std::uint16_t port);
    ~PolarisLine();
    PolarisLine(PolarisLine&& other) noexcept;
    PolarisLine& operator=(PolarisLine&&) = delete;

    /// Serves as long as `everyTurn`, which is called a hundred times a second or oftener, returns
    /// true.
    PolarisTraffic serve(PolarisDevice& device,
                         const std::function<bool(LocalTime now)>& everyTurn);

private:
    PolarisLine() = default;
    [[nodiscard]] int rate() const;
    void accept();
    [[nodiscard]] std::string read();
    void write(const std::string& bytes) const;

    int m_listener = -1; ///< of TCP
    int m_line = -1;     ///< the terminal's master, or a connection
    int m_held = -1; ///< the terminal's other end, so that it stays while no program has it open
    std::filesystem::path m_link;
};

} // namespace carina
