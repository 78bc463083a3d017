#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/igtl/igtl_reader.h"

#include <memory>
#include <set>

namespace carina
{

/// What a server of OpenIGTLink has to give at a moment, in a frame R that its user names.
struct IgtlOffer {
    struct Tool {
        std::string name; ///< at most 20 characters
        RigidTransform X_RO;
        bool isSeen = true; ///< or the last pose
    };
    struct Surface {
        std::string name;
        std::uint64_t stamp = 0;
        IgtlPolyData data;
    };

    std::uint64_t stamp = 0; ///< of the poses; of two offers with the same one the first counts
    std::vector<Tool> tools;
    std::shared_ptr<const IgtlPoints> landmarks; ///< never null
    std::shared_ptr<const Surface> surface;      ///< null where there is none
};

/// One client of a server of OpenIGTLink: what it has asked for, and what it is to be sent.
/// Without socket, clock and thread.
///
/// - A client that asks for something (GET_, STT_) within 300 ms gets what it asks for. Any other
///   gets everything, as those of 3D Slicer expect: a TRANSFORM for each tool and offer, the
///   landmarks when they change, the surface at most every kSurfaceInterval.
/// - A client is answered with the highest version of the header that it has used. With version 2 a
///   tool that is not seen is sent as such (TransformStatus), with version 1 it is left out.
/// - Nothing is queued: whoever is late gets the next offer, and who asks for the same thing ten
///   times gets it once.
/// - A client that nothing is sent to gets a STATUS every two seconds.
class IgtlSubscriber
{
public:
    static constexpr Duration kSurfaceInterval = std::chrono::milliseconds{100};

    explicit IgtlSubscriber(LocalTime connected);

    /// Bytes that have arrived of it.
    void take(std::span<const std::byte> bytes);
    /// Whether what comes is no OpenIGTLink: the connection is to be closed.
    [[nodiscard]] bool isLost() const { return m_reader.isLost(); }

    /// What is to be sent now.
    [[nodiscard]] std::vector<std::byte> due(const IgtlOffer& offer, LocalTime now);

private:
    /// Something it has asked for once: type and name.
    using Question = std::pair<std::string, std::string>;
    /// What it has asked for again and again.
    struct Course {
        bool isQuaternions = false;
        Duration interval{};
        LocalTime next{};
    };

    void take(const IgtlMessage& message);
    void answer(const Question& question, const IgtlOffer& offer);
    void push(const IgtlOffer& offer, LocalTime now);
    void sendTool(const IgtlOffer& offer, const IgtlOffer::Tool& tool);
    void sendTools(const IgtlOffer& offer, bool asQuaternions);
    void send(std::string device, std::uint64_t stamp, IgtlContent content,
              std::vector<IgtlMetadata> metadata = {});

    IgtlReader m_reader;
    LocalTime m_connected;
    bool m_asks = false;
    std::uint16_t m_version = 1;
    std::uint32_t m_id = 0;
    std::set<Question> m_questions;
    std::optional<Course> m_course;
    std::uint64_t m_sentStamp = 0;
    std::shared_ptr<const IgtlPoints> m_sentLandmarks;
    std::shared_ptr<const IgtlOffer::Surface> m_sentSurface;
    LocalTime m_surfaceDue;
    LocalTime m_sent; ///< anything
    std::vector<std::byte> m_out;
};

} // namespace carina
