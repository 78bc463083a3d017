#pragma once

#include "apps/lab/soak/soak_experiment.h"
#include "engine/net/node/session_node.h"

#include <QTemporaryDir>

namespace carina::lab
{

/// What happens in a session that is soaked: an instructor who changes the patient and its
/// breathing, and an observer who comes and goes.
class SoakScript
{
public:
    /// Joins as instructor. @returns what SessionNode::join does; WrongCode without a code for it.
    [[nodiscard]] static Result<std::unique_ptr<SoakScript>>
    of(const SoakSettings& settings, std::uint16_t port, const JoinCodes& codes);

    /// Whether this instructor and the trainee are in the session, which runs.
    [[nodiscard]] bool isReady() const;
    /// Why the host refuses this instructor or a proposal of it, if it does.
    [[nodiscard]] std::optional<Error> refusal() const;
    /// Does what is due. To be called often. @param since the beginning
    void step(Duration since);
    /// In the log so far.
    [[nodiscard]] std::uint64_t facts() const;
    /// Counts what was done.
    void report(SoakFigures& figures) const;

private:
    SoakScript(const SoakSettings& settings, std::uint16_t port, const JoinCodes& codes);

    [[nodiscard]] JoinSettings entry(Role role, const char* name) const;
    [[nodiscard]] bool isDue(int done, int times, Duration since) const;
    void changePatient();
    void changeBreathing();
    void comeOrGo();

    SoakSettings m_settings;
    std::uint16_t m_port;
    JoinCodes m_codes;
    QTemporaryDir m_tokens; ///< by which a guest comes back as the same participant
    std::unique_ptr<SessionNode> m_instructor;
    std::unique_ptr<SessionNode> m_guest; ///< null while the observer is away
    int m_patients = 0;
    int m_events = 0;
    int m_visits = 0;    ///< comings and goings of the guest
    int m_joins = 0;     ///< times the host admitted the guest
    bool m_isIn = false; ///< the guest of this visit was admitted
};

} // namespace carina::lab
