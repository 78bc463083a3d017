#pragma once

#include "engine/net/node/session_node.h"
#include "models/session/change_history.h"

namespace carina
{

/// By whoever takes a change back: proposes the fact that does it, or lets the change stay and has
/// the history say why.
/// @param why it stays, one sentence; empty: it is taken back
/// @param history null: nobody is told
void proposeBack(SessionNode& node, StationId station, FactBody body, const QString& why,
                 ChangeHistory* history);

} // namespace carina
