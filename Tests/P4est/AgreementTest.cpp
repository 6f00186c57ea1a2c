#include <Cutwater/P4est/Agreement.hpp>

#include <new>

#include "Ranks.hpp"

namespace cutwater::test {
namespace {

TEST(AgreementTest, WorkIsDoneOnAllRanks) {
  int done = 0;
  agreed(MPI_COMM_WORLD, [&] { ++done; });
  EXPECT_EQ(done, 1);
}

TEST(AgreementTest, ErrorOfOneRankReachesAll) {
  for (int failing = 0; failing < rankCount(); ++failing) {
    const auto text = expectAgreedError(ErrorKind::Topology, [&] {
      agreed(MPI_COMM_WORLD, [&] {
        if (ownRank() == failing) {
          throw Error(ErrorKind::Topology, "rank " + std::to_string(failing));
        }
      });
    });
    EXPECT_EQ(text, "rank " + std::to_string(failing));
  }
}

TEST(AgreementTest, RanksThatDifferAllFail) {
  for (const std::uint64_t same : {std::uint64_t{0}, std::uint64_t{77}, ~std::uint64_t{0}}) {
    EXPECT_NO_THROW(requireSame(MPI_COMM_WORLD, same, "differ"));
    for (int other = 0; rankCount() > 1 && other < rankCount(); ++other) {
      const auto text = expectAgreedError(ErrorKind::Argument, [&] {
        requireSame(MPI_COMM_WORLD, ownRank() == other ? same + 1 : same, "differ");
      });
      EXPECT_EQ(text, "differ");
    }
  }
}

TEST(AgreementTest, LowestRankSpeaksForAll) {
  const auto text = expectAgreedError(ErrorKind::File, [&] {
    agreed(MPI_COMM_WORLD, [&] {
      if (ownRank() >= rankCount() / 2) {
        throw Error(ErrorKind::File, "rank " + std::to_string(ownRank()));
      }
    });
  });
  EXPECT_EQ(text, "rank " + std::to_string(rankCount() / 2));
}

TEST(AgreementTest, OtherExceptionsArriveAsErrors) {
  expectAgreedError(ErrorKind::Limit, [] {
    agreed(MPI_COMM_WORLD, [] {
      if (ownRank() == rankCount() - 1) throw std::bad_alloc();
    });
  });
  const auto text = expectAgreedError(ErrorKind::Argument, [] {
    agreed(MPI_COMM_WORLD, [] {
      if (ownRank() == 0) throw std::runtime_error("");
    });
  });
  EXPECT_EQ(text, "");
}

}  // namespace
}  // namespace cutwater::test
