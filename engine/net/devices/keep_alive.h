#pragma once

class QAbstractSocket;

namespace carina
{

/// Lets the system notice within about ten seconds that the other end of a connected socket is gone
/// without a word: switched off, or its cable pulled.
void keepAlive(QAbstractSocket& socket);

} // namespace carina
